from nov import *
R='--set 418=0 --running --left 20 '
for i in (1,2): run([Cube(R+'--set 638=10 --set 424=500')],['--drive','acu','-a','1','statemachine','quick-stop'],triggers=[(T(.4),INT)],label='Ctrl-C',maxt=30)
B='target/debug/antrieb'
for fam in (['--drive','acu'],[]):
  for i in (1,2):
    with A.DriveServer(A.options('--family acu --protocol ascii --set 418=0 --running --left 20 --set 638=10')) as s:
        p=subprocess.run([B,'--no-config','-p',s.path,'--protocol','ascii',*fam,'-a','1','statemachine','quick-stop'],stdin=subprocess.DEVNULL,capture_output=True,timeout=60)
        print('ascii',fam,'rc',p.returncode,p.stderr.decode()[:150].replace('\n','|'),[x for x in s.drive.writes])
