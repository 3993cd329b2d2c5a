fff_tests(tests_nesting LIBRARIES fff::core Polyclipping::Polyclipping TESTS
    core/nesting/tst_collision
    core/nesting/tst_nester
    core/nesting/tst_nesting_cases
    core/nesting/tst_proof)
