target_sources(fff_session PRIVATE
    analysis.cpp
    autosave.cpp
    check_list.cpp
    check_text.cpp
    checks.cpp
    cutting_file.cpp
    journal.cpp
    pen_commands.cpp
    point_commands.cpp
    recovery.cpp
    replay.cpp
    replay_script.cpp
    session.cpp
    session_commands.cpp
    session_host.cpp
    tool_commands.cpp
)
