"""Tests of isa_symbols.py."""
import unittest

import isa_symbols

LISTING = """0000 T carom::detail::avx2_passes()
0010 W void carom::detail::solve_rows<carom::detail::Lanes<8>, 1>(void*, unsigned long, unsigned long, float*)
0020 W std::array<float, 2ul>::operator[](unsigned long)
0028 W bool carom::detail::any<8>(carom::detail::LaneMask<8>)
0030 t local
0040 u carom::detail::solver_passes<carom::detail::Lanes<8> >
"""


class Strangers(unittest.TestCase):
    def test_names_what_has_no_lane_type(self):
        self.assertEqual(isa_symbols.strangers(LISTING, "8"), ["std::array<float, 2ul>::operator[](unsigned long)"])

    def test_another_width_is_a_stranger(self):
        self.assertEqual(len(isa_symbols.strangers(LISTING, "16")), 4)


if __name__ == "__main__":
    unittest.main()
