# Completion of flatfitfab-cli in bash; made by packaging/linux/pages.py.
_flatfitfab_cli()
{
    local word=$2 before=$3 flags=
    COMPREPLY=()
    if [ "$COMP_CWORD" = 1 ]; then
        COMPREPLY=($(compgen -W 'info check simulate parts export render steps values variants operations cut suggest slices facets nest replay --help --version' -- "$word"))
        return
    fi
    case "${COMP_WORDS[1]}:$before" in
    export:--format) COMPREPLY=($(compgen -W 'svg dxf pdf lbrn2 gcode csv png zip obj stl 3mf fff' -- "$word")); return ;;
    export:--machine) COMPREPLY=($(compgen -W 'generic trotec lightburn k40 falcon2-pro falcon-a1 sculpfun-s30 tts-55 ortur xtool-d1-pro polar co2-60w nova-35 s40-max' -- "$word")); return ;;
    nest:--rotations) COMPREPLY=($(compgen -W 'none 180 90 free' -- "$word")); return ;;
    replay:--format) COMPREPLY=($(compgen -W 'svg dxf pdf lbrn2 gcode csv png zip obj stl 3mf fff' -- "$word")); return ;;
    replay:--machine) COMPREPLY=($(compgen -W 'generic trotec lightburn k40 falcon2-pro falcon-a1 sculpfun-s30 tts-55 ortur xtool-d1-pro polar co2-60w nova-35 s40-max' -- "$word")); return ;;
    esac
    case "${COMP_WORDS[1]}" in
    info) flags='--json --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    check) flags='--json --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    simulate) flags='--accurate --lasting --weight --json --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    parts) flags='--json --tolerance --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    export) flags='-o --output --format --no-reference --joint-colours --margin --spacing --no-turning --nest --sheets --machine --skin --tabs --lead --common-lines --coupon --dxf --paper --parts --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    render) flags='-o --output --size --view --show --accurate --template --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    steps) flags='-o --output --paper --size --view --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    values) flags='--json --try --seed --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    variants) flags='--table -o --output --format --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    operations) flags='--json --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    cut) flags='--plane --size --json -h --help' ;;
    suggest) flags='-o --output --size --count --seed --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    slices) flags='-o --output --size --along --count --spacing --hollow --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    facets) flags='-o --output --size --faces --unfold --flap --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    nest) flags='--json --seconds --seed --rotations --margin --spacing --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    replay) flags='--from --template -o --output --format --no-reference --joint-colours --margin --spacing --no-turning --nest --sheets --machine --skin --tabs --lead --common-lines --coupon --dxf --paper --parts --set --thickness --stock --kerf --clearance --sheet --offcut --unit-mm --verbose -h --help' ;;
    esac
    if [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$flags" -- "$word"))
    else
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
    fi
}
complete -o filenames -F _flatfitfab_cli flatfitfab-cli
