target_sources(fff_session PRIVATE
    analysis.cpp
    session.cpp
)
