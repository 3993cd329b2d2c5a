fff_test(core/stroke/tst_stroke fff::core)
fff_test(core/stroke/tst_symmetry fff::core)
fff_test(core/stroke/tst_pen_path fff::core)
