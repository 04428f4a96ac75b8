from sc import *
import sys
def lv(c,f=lambda s:s.leave('wd'),nm='leave'): return lambda s:s.when(c,f,nm)
def mutewd(T):
    def on(s): s.mute=True; t1=time.monotonic(); s.when(lambda s:time.monotonic()-t1>T,lambda s:setattr(s,'mute',False),'unmute')
    return on
def cyc(T):
    def off(s): s.poweroff(); t1=time.monotonic(); s.when(lambda s:time.monotonic()-t1>T,lambda s:s.poweron(),'on')
    return off
c600=lambda s:s.hsw==0x1999 and s.pkw_due and s.pkw_last[:2]==b'\x12\x58'
c611=lambda s:s.hsw==0x200 and s.pkw_due and s.pkw_last[:2]==b'\x12\x63'
c928=lambda s:s.gw[928]==1 and s.pkw_last and s.pkw_last[:2]==b'\x13\xa0' and s.pkw_due
NW=tuple(x for x in RUN if x not in('--watchdog','1s'))
