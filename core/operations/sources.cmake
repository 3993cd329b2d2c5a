target_sources(fff_core PRIVATE
    operations/baking.cpp
    operations/blend.cpp
    operations/evaluate.cpp
    operations/linear.cpp
    operations/operation_context.cpp
    operations/operation_kind.cpp
    operations/operation_kinds.cpp
    operations/placement.cpp
    operations/repeat_parameters.cpp
    operations/revolve.cpp
    operations/root_edge.cpp
    operations/row.cpp
    operations/section_lookup.cpp
    operations/source_crossing.cpp
)
