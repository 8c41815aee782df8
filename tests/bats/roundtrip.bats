#!/usr/bin/env bats
# Programs of Filum, read back: time, lengths by class and volume stay within half a percent.
# All profiles and kinds: tests/roundtrip/compare-programs.

@test "a program that is read back has the time, lengths and volume of its toolpath" {
    "$FILUM_SOURCE/tests/roundtrip/compare-programs" --profiles marlin,cellink-inkredible,klipper-xyzac,polar-xzbc --kinds solid,hollow
}
