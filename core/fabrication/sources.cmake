target_sources(fff_core PRIVATE
    fabrication/cut_section.cpp
    fabrication/kerf.cpp
    fabrication/layout.cpp
    fabrication/parts.cpp
    fabrication/summary.cpp
)
