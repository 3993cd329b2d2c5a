fff_tests(tests_model LIBRARIES fff::core TESTS
    core/base/tst_expression
    core/base/tst_groups
    core/model/tst_changes
    core/model/tst_document
    core/model/tst_edits
    core/model/tst_ground
    core/model/tst_moving
    core/model/tst_named_numbers
    core/model/tst_naming
    core/model/tst_point_edits
    core/model/tst_shape
    core/model/tst_transformed
    ALONE
        core/model/tst_edits
        core/model/tst_transformed)
