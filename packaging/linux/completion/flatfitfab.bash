# Completion of flatfitfab in bash; made by packaging/linux/pages.py.
_flatfitfab()
{
    local word=$2 before=$3 flags=
    COMPREPLY=()
    flags='-h --help --help-all -v --version --copy --play --safe-mode'
    if [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$flags" -- "$word"))
    else
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
    fi
}
complete -o filenames -F _flatfitfab flatfitfab
