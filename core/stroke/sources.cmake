target_sources(fff_core PRIVATE
    stroke/calmed_line.cpp
    stroke/closed_fit.cpp
    stroke/filled_line.cpp
    stroke/leaving.cpp
    stroke/line_ends.cpp
    stroke/meant_line.cpp
    stroke/meant_shape.cpp
    stroke/pen_path.cpp
    stroke/small_round.cpp
    stroke/steady_hand.cpp
    stroke/straightened.cpp
    stroke/stroke.cpp
    stroke/stroke_contour.cpp
    stroke/symmetry.cpp
    stroke/thinned_line.cpp
    stroke/twitch.cpp
)
