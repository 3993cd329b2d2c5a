target_sources(fff_view PRIVATE
)
