# Whatever the input: an end, an exit code, a word, no half-made file.

@test "every bad input keeps the rules" {
    run "$BATS_TEST_DIRNAME/../../scripts/bad-input" --check
    echo "$output"
    [ "$status" -eq 0 ]
}
