fff_tests(tests_physics LIBRARIES fff::core Polyclipping::Polyclipping TESTS
    core/physics/tst_balance
    core/physics/tst_elastic_equilibrium
    core/physics/tst_elastic_sharing
    core/physics/tst_equilibrium
    core/physics/tst_equilibrium_extremes
    core/physics/tst_equilibrium_laws
    core/physics/tst_frontal_factors
    core/physics/tst_line_cut
    core/physics/tst_link_stiffness
    core/physics/tst_neck
    core/physics/tst_plate_flexibility
    core/physics/tst_plate_mesh
    core/physics/tst_plate_model
    core/physics/tst_section_extremes
    core/physics/tst_section_stress
    core/physics/tst_sparse_field
    core/physics/tst_stress_field
    core/physics/tst_wall_pressure
    ALONE
        core/physics/tst_elastic_equilibrium
        core/physics/tst_equilibrium
        core/physics/tst_equilibrium_laws
        core/physics/tst_plate_model
        core/physics/tst_section_stress
        core/physics/tst_stress_field
        core/physics/tst_wall_pressure)
target_sources(tests_physics PRIVATE
    core/physics/reference_case.cpp
    core/physics/reference_plates.cpp
    core/physics/reference_section.cpp
    core/physics/reference_truth.cpp)

# What compares with reference cases, for any folder of them: a program of its own.
add_executable(tst_reference_cases
    ${CMAKE_CURRENT_LIST_DIR}/compare_beams.cpp
    ${CMAKE_CURRENT_LIST_DIR}/compare_elastic.cpp
    ${CMAKE_CURRENT_LIST_DIR}/compare_plates.cpp
    ${CMAKE_CURRENT_LIST_DIR}/compare_rigid.cpp
    ${CMAKE_CURRENT_LIST_DIR}/reference_case.cpp
    ${CMAKE_CURRENT_LIST_DIR}/reference_index.cpp
    ${CMAKE_CURRENT_LIST_DIR}/reference_plates.cpp
    ${CMAKE_CURRENT_LIST_DIR}/reference_report.cpp
    ${CMAKE_CURRENT_LIST_DIR}/reference_section.cpp
    ${CMAKE_CURRENT_LIST_DIR}/reference_truth.cpp
    ${CMAKE_CURRENT_LIST_DIR}/tst_reference_cases.cpp)
target_link_libraries(tst_reference_cases PRIVATE fff::core Qt6::Core)
target_compile_definitions(tst_reference_cases PRIVATE FFF_SHARED="${FFF_TESTS_FOLDER}/../../shared")
fff_batches(tst_reference_cases)
add_test(NAME core/physics/tst_reference_cases COMMAND tst_reference_cases)
add_test(NAME core/physics/tst_reference_cases_of_our_own
    COMMAND tst_reference_cases --cases ${FFF_TESTS_FOLDER}/data/mechanics)
