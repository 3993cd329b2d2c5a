fff_test(core/session/tst_session fff::session)
