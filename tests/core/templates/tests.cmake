fff_tests(tests_templates LIBRARIES fff::core CGAL::CGAL TESTS
    core/templates/tst_flat_template
    core/templates/tst_guide_curve
    core/templates/tst_magnetic_cut
    core/templates/tst_mended_mesh
    core/templates/tst_mesh_nets
    core/templates/tst_mesh_tree
    core/templates/tst_plane_cut
    core/templates/tst_plane_cut_oracle
    core/templates/tst_pulled_templates
    core/templates/tst_stood_mesh
    core/templates/tst_thinned_mesh
    core/templates/tst_traced_picture
    ALONE
        core/templates/tst_plane_cut_oracle) # CGAL's slicer
