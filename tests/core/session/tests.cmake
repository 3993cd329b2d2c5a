fff_test(core/session/tst_session fff::session)
fff_test(core/session/tst_replay fff::session)
fff_test(core/session/tst_autosave fff::session)
fff_test(core/session/tst_layout_models fff::session Polyclipping::Polyclipping)
