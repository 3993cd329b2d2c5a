fff_tests(tests_io LIBRARIES fff::io OpenMeshCore ZLIB::ZLIB TESTS
    core/io/tst_broken_meshes
    core/io/tst_cutting_formats
    core/io/tst_document_file
    core/io/tst_error_text
    core/io/tst_fff_file
    core/io/tst_fff_format
    core/io/tst_fff_migration
    core/io/tst_fff_values
    core/io/tst_file_set
    core/io/tst_flatfab_format
    core/io/tst_flatfab_models
    core/io/tst_full_stop
    core/io/tst_formats
    core/io/tst_joint_colours
    core/io/tst_json_writer
    core/io/tst_machine_library
    core/io/tst_material_library
    core/io/tst_offcut_file
    core/io/tst_mesh_readers
    core/io/tst_obj_writer
    core/io/tst_stock_file
    core/io/tst_svg_reader
    core/io/tst_svg_writer
    core/io/tst_template_files
    core/io/tst_warning_summary
    core/io/tst_workshop_files
    ALONE
        core/io/tst_flatfab_models)

# The schema and the reader agree, on all documents that are here and on thousands of changed ones.
add_executable(fff_verdicts core/io/fff_verdicts.cpp)
target_link_libraries(fff_verdicts PRIVATE fff::io)
# The system's Python: python3-jsonschema is a package of it.
find_program(FFF_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(FFF_PYTHON python3 REQUIRED)
file(GLOB FFF_DOCUMENTS CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/resources/samples/*.fff
    ${CMAKE_CURRENT_SOURCE_DIR}/data/fff/*.fff ${CMAKE_CURRENT_SOURCE_DIR}/data/migration/version_1.fff
    ${CMAKE_CURRENT_SOURCE_DIR}/data/migration/version_2.fff
    ${CMAKE_CURRENT_SOURCE_DIR}/data/migration/version_3.fff
    ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/seeds/fff/*.fff)
add_test(NAME core/io/fff_schema COMMAND ${FFF_PYTHON}
    ${CMAKE_CURRENT_SOURCE_DIR}/core/io/check_schema.py
    ${CMAKE_SOURCE_DIR}/resources/schema/fff-3.schema.json $<TARGET_FILE:fff_verdicts> ${FFF_DOCUMENTS})
