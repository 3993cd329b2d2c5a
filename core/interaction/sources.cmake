target_sources(fff_core PRIVATE
    interaction/camera.cpp
    interaction/click_selection.cpp
    interaction/commands.cpp
    interaction/facing.cpp
    interaction/interaction.cpp
    interaction/pick.cpp
    interaction/stroke_gesture.cpp
    interaction/view_gestures.cpp
)
