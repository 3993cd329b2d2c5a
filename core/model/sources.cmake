target_sources(fff_core PRIVATE
    model/changes.cpp
    model/document.cpp
    model/edits.cpp
    model/ground.cpp
    model/instance_key.cpp
    model/mapped_shape.cpp
    model/materials.cpp
    model/mended_shape.cpp
    model/model.cpp
    model/naming.cpp
    model/origin.cpp
    model/operation_edits.cpp
    model/point_edits.cpp
    model/section.cpp
    model/shape.cpp
    model/stock.cpp
)
