fff_test(core/assembly/tst_intervals fff::core)
fff_test(core/assembly/tst_slits fff::core)
fff_test(core/assembly/tst_assembly fff::core)
fff_test(core/assembly/tst_shared_models fff::io)
