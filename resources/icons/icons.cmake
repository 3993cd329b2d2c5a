# Icons are drawn as SVG and built as alpha masks at 1x, 2x and 3x, so that running needs no SVG reader.
# Embedded in fff_ui as :/icons/NAME.png, NAME@2x.png, NAME@3x.png.
find_program(RSVG_CONVERT rsvg-convert REQUIRED)
set(icon_names
    about
    align
    array
    bake
    blend
    branch
    check
    chevron_down
    chevron_right
    clock
    close
    close_window
    copy
    cut
    cut_at_ground
    cut_open
    detach
    dimension
    docks
    drop_to_ground
    duplicate
    engrave
    err
    export
    export_again
    eye
    eye_off
    face_section
    figure_circle
    figure_draw
    figure_ellipse
    figure_polygon
    figure_rectangle
    figure_slot
    figure_star
    fit
    fit_selection
    float
    free
    full_screen
    grid
    ground_shadow
    hand_on
    help
    hide
    hole
    holes_remove
    import_drawing
    in_space
    insert_model
    isolate
    joint
    joint_flip
    joint_reset
    keep
    keyboard
    linear
    lock
    lock_open
    measure
    mirror
    mirror_copy
    mouse
    move_down
    move_up
    new
    next_pane
    next_problem
    note
    open
    operation_switch
    orthogonal
    paste
    pause
    pen
    perspective
    pick
    picture
    pin
    plane_front
    plane_ground
    plane_parallel
    plane_side
    play
    plus
    point_add
    point_corner
    point_remove
    point_smooth
    point_symmetric
    previous_pane
    previous_problem
    pull
    push
    put_on
    quit
    radial
    redo
    redraw
    reset_window
    revert
    revolve
    rotational
    save
    save_as
    score
    search
    section
    select_all
    select_connected
    select_parallel
    settings
    show_all
    skin
    slices
    snap
    start
    step_next
    step_previous
    steps
    stocks
    stress
    symmetry
    transform
    trash
    undo
    unknown
    value
    view_back
    view_bottom
    view_front
    view_iso
    view_left
    view_previous
    view_right
    view_top
    warn
    weight
    with_children
    working
    xray)
set(icon_folder ${CMAKE_CURRENT_BINARY_DIR}/icons)
file(MAKE_DIRECTORY ${icon_folder})
set(icon_masks)
foreach(name ${icon_names})
    set(source ${CMAKE_CURRENT_LIST_DIR}/${name}.svg)
    foreach(scale 1 2 3)
        set(suffix)
        if(scale GREATER 1)
            set(suffix "@${scale}x")
        endif()
        set(mask ${icon_folder}/${name}${suffix}.png)
        math(EXPR size "24 * ${scale}")
        add_custom_command(OUTPUT ${mask}
            COMMAND ${RSVG_CONVERT} -w ${size} -h ${size} -o ${mask} ${source}
            DEPENDS ${source} VERBATIM)
        list(APPEND icon_masks ${mask})
    endforeach()
endforeach()
qt_add_resources(fff_ui icons PREFIX /icons BASE ${icon_folder} FILES ${icon_masks})
