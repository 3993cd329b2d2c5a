fff_test(core/io/tst_json_writer fff::io)
fff_test(core/io/tst_fff_format fff::io)
fff_test(core/io/tst_flatfab_format fff::io)
fff_test(core/io/tst_flatfab_models fff::io)
fff_test(core/io/tst_document_file fff::io)
fff_test(core/io/tst_error_text fff::io)
fff_test(core/io/tst_svg_reader fff::io)
fff_test(core/io/tst_svg_writer fff::io)
fff_test(core/io/tst_obj_writer fff::io OpenMeshCore)
fff_test(core/io/tst_file_set fff::io)
fff_test(core/io/tst_fff_migration fff::io)

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
