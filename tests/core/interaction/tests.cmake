fff_test(core/interaction/tst_camera fff::core)
fff_test(core/interaction/tst_pick fff::core)
fff_test(core/interaction/tst_interaction fff::session)
