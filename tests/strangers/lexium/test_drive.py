"""The drive itself, against what the manual prints: python3 -m unittest test_drive"""

import unittest

from lexium05 import AT, Device, Readings
from wire import crc, framed


def write(name, value):
    return bytes([16]) + AT[name].to_bytes(2, "big") + b"\0\2\4" + (value & 0xFFFFFFFF).to_bytes(4, "big")


def read(name, count=2):
    return bytes([3]) + AT[name].to_bytes(2, "big") + count.to_bytes(2, "big")


class Printed(unittest.TestCase):
    """Telegrams and sequences of chapters 5 and 6."""

    def setUp(self):
        self.drive = Device(Readings(), 0.0)

    def do(self, *pairs):
        for name, value in pairs:
            self.assertEqual(self.drive.serve(write(name, value))[0], 16, name)
            self.drive.advance(self.drive.now + 0.2)

    def enable(self):
        self.do(("DCOMcontrol", 0), ("DCOMcontrol", 6), ("DCOMcontrol", 15))
        self.assertEqual(self.drive.status() & 0x0F, 7)

    def test_check_value_of_a_known_telegram(self):
        self.assertEqual(framed(1, bytes.fromhex("03 01 e0 00 01")).hex(), "010301e000018400")
        self.assertEqual(crc(b""), b"\xff\xff")

    def test_example_1_reads_four_rows_at_once(self):
        reply = self.drive.serve(read("FLT_err_num", 8))
        self.assertEqual((reply[0], reply[1], len(reply)), (3, 16, 18))

    def test_example_2_writes_two_rows_at_once(self):
        request = bytes.fromhex("10 06 08 00 04 08 00 00 10 00 ff ff f0 00")
        self.assertEqual(self.drive.serve(request), request[:5])
        self.assertEqual(self.drive.value["SPVswLimNusr"], -4096)

    def test_identification(self):
        reply = self.drive.serve(bytes.fromhex("2b 0e 01 00"))
        self.assertEqual(reply[:7], bytes.fromhex("2b 0e 01 02 00 00 03"))
        self.assertEqual(self.drive.serve(bytes.fromhex("2b 0d 01 00")), bytes.fromhex("ab 0e 01"))

    def test_odd_addresses_and_counts_are_refused(self):
        self.assertEqual(self.drive.serve(bytes.fromhex("03 06 15 00 02"))[0], 0x83)
        self.assertEqual(self.drive.serve(bytes.fromhex("03 06 14 00 01"))[0], 0x83)

    def test_reserved_sub_functions_are_refused(self):
        for sub in (3, 5, 14, 15, 19):
            self.assertEqual(self.drive.serve(bytes([8, 0, sub, 0, 0]))[0], 0x88)

    def test_last_synchronous_error(self):
        self.drive.serve(write("PPn_target", 0))
        reply = self.drive.serve(bytes.fromhex("08 00 02 00 00"))
        self.assertEqual(reply, bytes.fromhex("08 00 02 11 00"))

    def test_word_order(self):
        self.drive.in_force["MBdword_order"] = 1
        self.assertEqual(self.drive.serve(read("RAMPacc"))[2:], bytes.fromhex("02 58 00 00"))

    def test_velocity_profile_5_4_2(self):
        self.enable()
        self.do(("RAMPacc", 2000), ("RAMPdecel", 10000), ("DCOMopmode", 3), ("PVn_target", 1000))
        self.drive.advance(self.drive.now + 1.0)
        self.assertAlmostEqual(self.drive.axis.speed, 1000, delta=1)
        self.assertTrue(self.drive.status() & 0x400)
        self.do(("PVn_target", 0))
        self.assertTrue(self.drive.axis.still)

    def test_point_to_point_5_4_1(self):
        self.do(("PPn_target", 4000), ("RAMPacc", 2000), ("RAMPdecel", 4000))
        self.enable()
        self.do(("DCOMopmode", 1), ("PPp_targetusr", 5 * 16384), ("DCOMcontrol", 0x5F))
        self.drive.advance(self.drive.now + 3.0)
        self.assertAlmostEqual(self.drive.axis.turns, 5.0)
        self.assertTrue(self.drive.status() & 0x400)

    def test_homing_5_4_3(self):
        self.do(("HMn", 100), ("HMn_out", 10))
        self.enable()
        self.do(("DCOMopmode", 6), ("HMmethod", 17), ("DCOMcontrol", 0x1F))
        self.drive.advance(self.drive.now + 5.0)
        self.assertTrue(self.drive.status() & 0x1000)

    def test_modes_of_5_5(self):
        for mode, rows in ((-3, (("CURreference", 2), ("CUR_I_target", 200))),
                           (-4, (("SPEEDreference", 2), ("SPEEDn_target", 500))),
                           (-2, (("GEARreference", 1), ("GEARdenom", 3), ("GEARnum", 2))),
                           (-1, (("JOGactivate", 5),))):
            self.setUp()
            self.enable()
            self.do(("DCOMopmode", mode), *rows)
            self.drive.advance(self.drive.now + 0.5)
            self.assertGreater(self.drive.axis.speed, 100, mode)

    def test_node_guarding_5_6(self):
        self.enable()
        self.do(("DCOMopmode", 3), ("PVn_target", 300), ("MBnode_guard", 500))
        self.drive.advance(self.drive.now + 1.0)
        self.assertEqual(self.drive.state, "quick stop")
        self.assertTrue(self.drive.axis.still)
        self.do(("DCOMcontrol", 15))
        self.assertEqual(self.drive.state, "quick stop")
        self.do(("DCOMcontrol", 0))
        self.assertEqual(self.drive.state, "switch-on disabled")

    def test_a_mode_change_while_turning_is_refused_6_3_1(self):
        self.enable()
        self.do(("DCOMopmode", 3), ("PVn_target", 300))
        self.assertEqual(self.drive.serve(write("DCOMopmode", 1)), bytes([0x90, 4]))
        self.assertEqual(self.drive.mode, 3)


if __name__ == "__main__":
    unittest.main()
