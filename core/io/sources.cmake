target_sources(fff_io PRIVATE
    document_file.cpp
    drawing_text.cpp
    error_text.cpp
    fff_migration.cpp
    fff_operations.cpp
    fff_reader.cpp
    fff_writer.cpp
    file_set.cpp
    flatfab_format.cpp
    flatfab_text.cpp
    json_cursor.cpp
    json_syntax.cpp
    json_writer.cpp
    loaded_document.cpp
    obj_writer.cpp
    svg_writer.cpp
)
