fff_test(ui/settings/tst_settings fff::ui)
fff_test(ui/tst_lengths fff::ui)
fff_test(ui/tst_measures fff::ui)
fff_test(ui/tst_slab_mesh fff::view)

# A real window with a real OpenGL view: needs a display, which tests/run provides.
fff_test(ui/tst_main_window fff::ui)
set_tests_properties(ui/tst_main_window PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")
