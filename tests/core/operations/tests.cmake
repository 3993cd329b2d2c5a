fff_tests(tests_operations LIBRARIES fff::io TESTS
    core/operations/tst_array
    core/operations/tst_baking
    core/operations/tst_blend
    core/operations/tst_branch
    core/operations/tst_evaluate
    core/operations/tst_excerpt
    core/operations/tst_global_symmetry
    core/operations/tst_facet_model
    core/operations/tst_grid
    core/operations/tst_linear
    core/operations/tst_moving_model
    core/operations/tst_radial
    core/operations/tst_revolve
    core/operations/tst_row
    core/operations/tst_slices
    core/operations/tst_slices_along
    core/operations/tst_template_edits)
