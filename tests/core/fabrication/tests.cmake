fff_tests(tests_fabrication LIBRARIES fff::session TESTS
    core/fabrication/tst_cutting_order
    core/fabrication/tst_kerf
    core/fabrication/tst_kerf_oracle
    core/fabrication/tst_layout
    core/fabrication/tst_marks
    core/fabrication/tst_part_list
    core/fabrication/tst_parts)
