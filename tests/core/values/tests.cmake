fff_tests(tests_values LIBRARIES fff::core TESTS
    core/values/tst_formula
    core/values/tst_presets
    core/values/tst_values)
