fff_test(app/tst_cli fff::io)
target_compile_definitions(tst_cli PRIVATE FFF_CLI="$<TARGET_FILE:flatfitfab-cli>")
add_dependencies(tst_cli flatfitfab-cli)
