fff_tests(tests_assembly LIBRARIES fff::session Polyclipping::Polyclipping TESTS
    core/assembly/tst_assembly
    core/assembly/tst_body
    core/assembly/tst_cut_section
    core/assembly/tst_intervals
    core/assembly/tst_joint_override
    core/assembly/tst_joint_state
    core/assembly/tst_lobes
    core/assembly/tst_playback
    core/assembly/tst_shared_models
    core/assembly/tst_slab
    core/assembly/tst_slit_form
    core/assembly/tst_slits
    core/assembly/tst_smallest_sink
    core/assembly/tst_stability
    core/assembly/tst_tabs
    core/assembly/tst_trim
    core/assembly/tst_webs)
