# Completion of flatfitfab in fish; made by packaging/linux/pages.py.
complete -c flatfitfab -s h -l help -d 'Displays help on commandline options.'
complete -c flatfitfab -l help-all -d 'Displays help including Qt specific options.'
complete -c flatfitfab -s v -l version -d 'Displays version information.'
complete -c flatfitfab -l copy -d 'Opens FILE as a copy: saving asks for a name.'
complete -c flatfitfab -l play -r -d 'Plays a script of presses and moves.'
complete -c flatfitfab -l safe-mode -d 'Starts without what was set, and keeps no settings.'
