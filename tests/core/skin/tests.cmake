fff_tests(tests_skin LIBRARIES fff::core fff::io TESTS
    core/skin/tst_contour_network
    core/skin/tst_patch_judge
    core/skin/tst_skin)
target_compile_definitions(tests_skin PRIVATE FFF_SAMPLES="${CMAKE_SOURCE_DIR}/resources/samples")
