target_sources(fff_io PRIVATE
)
