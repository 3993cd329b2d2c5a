target_sources(fff_ui PRIVATE
)
