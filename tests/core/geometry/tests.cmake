fff_test(core/geometry/tst_fit fff::core)
