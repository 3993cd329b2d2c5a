fff_test(core/stroke/tst_stroke fff::core)
