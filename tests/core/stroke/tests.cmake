fff_tests(tests_stroke LIBRARIES fff::core TESTS
    core/stroke/tst_forgiving_ends
    core/stroke/tst_forgiving_shapes
    core/stroke/tst_guided_line
    core/stroke/tst_long_strokes
    core/stroke/tst_meant_shape
    core/stroke/tst_pen_path
    core/stroke/tst_slit_neck
    core/stroke/tst_stroke
    core/stroke/tst_stroke_contour
    core/stroke/tst_stroke_corpus
    core/stroke/tst_symmetry
    ALONE
        core/stroke/tst_meant_shape
        core/stroke/tst_forgiving_ends
        core/stroke/tst_forgiving_shapes
        core/stroke/tst_stroke_contour
        core/stroke/tst_symmetry)
