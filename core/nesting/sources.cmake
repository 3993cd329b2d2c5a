target_sources(fff_core PRIVATE
    nesting/board.cpp
    nesting/collision.cpp
    nesting/exploration.cpp
    nesting/filling.cpp
    nesting/first_layout.cpp
    nesting/grown_outline.cpp
    nesting/nester.cpp
    nesting/poles.cpp
    nesting/posed.cpp
    nesting/prepared.cpp
    nesting/proof.cpp
    nesting/search.cpp
    nesting/separation.cpp
    nesting/shape.cpp
    nesting/sliding.cpp
)
