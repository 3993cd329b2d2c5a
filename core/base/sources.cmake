target_sources(fff_core PRIVATE
    base/expression.cpp
    base/fault_point.cpp
    base/letters.cpp
    base/message.cpp
    base/utf8.cpp
    base/written_number.cpp)
# Else only headers: groups.h, ids.h, result.h, text.h, tolerances.h, units.h
