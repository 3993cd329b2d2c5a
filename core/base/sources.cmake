target_sources(fff_core PRIVATE
    base/expression.cpp
    base/fault_point.cpp
    base/message.cpp
    base/utf8.cpp)
# Else only headers: groups.h, ids.h, result.h, text.h, tolerances.h, units.h
