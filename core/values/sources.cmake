target_sources(fff_core PRIVATE
    values/evaluated_values.cpp
    values/expression_error.cpp
    values/formula.cpp
    values/formula_calls.cpp
    values/formula_parser.cpp
    values/formula_text.cpp
    values/formula_worth.cpp
    values/function_names.cpp
    values/number_text.cpp
    values/presets.cpp
    values/renaming.cpp
    values/text_template.cpp
    values/tokens.cpp
    values/typed.cpp
    values/unit_signs.cpp
    values/value_edits.cpp
    values/value_graph.cpp
    values/values.cpp
    values/worth.cpp)
# Else only headers: expression_words.h
