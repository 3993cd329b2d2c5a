target_sources(fff_core PRIVATE
)
