target_sources(fff_core PRIVATE
    fabrication/cutting_drawing.cpp
    fabrication/cutting_order.cpp
    fabrication/digits.cpp
    fabrication/kerf.cpp
    fabrication/layout.cpp
    fabrication/machine.cpp
    fabrication/marked_lines.cpp
    fabrication/marks.cpp
    fabrication/open_sheets.cpp
    fabrication/outline_size.cpp
    fabrication/part_list.cpp
    fabrication/parts.cpp
    fabrication/room.cpp
    fabrication/skyline.cpp
    fabrication/summary.cpp
    fabrication/wholeness.cpp
)
