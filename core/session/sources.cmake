target_sources(fff_session PRIVATE
    analysis.cpp
    cutting_file.cpp
    replay.cpp
    session.cpp
    session_commands.cpp
    session_host.cpp
)
