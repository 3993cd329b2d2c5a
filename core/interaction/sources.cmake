target_sources(fff_core PRIVATE
    interaction/camera.cpp
    interaction/click_selection.cpp
    interaction/clip_gesture.cpp
    interaction/commands.cpp
    interaction/facing.cpp
    interaction/hovering.cpp
    interaction/interaction.cpp
    interaction/pick.cpp
    interaction/problem_marks.cpp
    interaction/sight.cpp
    interaction/stroke_gesture.cpp
    interaction/view_cube.cpp
    interaction/view_gestures.cpp
    interaction/view_history.cpp
    interaction/view_motion.cpp
)
