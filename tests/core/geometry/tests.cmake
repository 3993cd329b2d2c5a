fff_test(core/geometry/tst_boolean fff::core)
fff_test(core/geometry/tst_fit fff::core)
