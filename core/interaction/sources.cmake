target_sources(fff_core PRIVATE
    interaction/camera.cpp
    interaction/pick.cpp
)
