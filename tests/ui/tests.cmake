fff_test(ui/tst_slab_mesh fff::view)

if(FFF_BUILD_WINDOW)
    # A real window with a real OpenGL view: needs a display, which tests/run provides.
    fff_test(ui/tst_main_window fff::ui)
    set_tests_properties(ui/tst_main_window PROPERTIES LABELS gl ENVIRONMENT "QT_QPA_PLATFORM=xcb")
endif()
