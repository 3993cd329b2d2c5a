target_sources(fff_core PRIVATE
    operations/evaluate.cpp
)
