fff_tests(tests_fabrication LIBRARIES fff::session Polyclipping::Polyclipping TESTS
    core/fabrication/tst_hand_placing
    core/fabrication/tst_cut_finish
    core/fabrication/tst_cutting_order
    core/fabrication/tst_fit_coupon
    core/fabrication/tst_kerf
    core/fabrication/tst_kerf_oracle
    core/fabrication/tst_layout
    core/fabrication/tst_marks
    core/fabrication/tst_nested_layout
    core/fabrication/tst_offcuts
    core/fabrication/tst_part_list
    core/fabrication/tst_parts
    core/fabrication/tst_swept_files)
