fff_test(core/model/tst_document fff::core)
fff_test(core/model/tst_edits fff::core)
fff_test(core/model/tst_shape fff::core)
fff_test(core/model/tst_naming fff::core)
