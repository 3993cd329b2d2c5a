; Installs FlatFitFab for this person; /AllUsers, as administrator, for everybody on this computer. /S asks nothing, /D=FOLDER
; (last, without quotes) chooses the folder. packaging/make gives VERSION, FOLDER (what to install), SIZE (kB), FILES, ICON and OUTPUT.
; Exit status: 0 done, 1 cancelled, 2 not enough rights, 3 the program is open.
Unicode true
Target amd64-unicode
RequestExecutionLevel user
SetCompressor /SOLID lzma
SetDateSave off ; two builds give the same bytes
ManifestDPIAware true
ManifestSupportedOS Win10

!include MUI2.nsh
!include FileFunc.nsh
!include "${FILES}" ; InstallFiles and RemoveFiles, for each file of FOLDER

!define OF_PROGRAM "Software\Microsoft\Windows\CurrentVersion\Uninstall\FlatFitFab"
!define CLASSES "Software\Classes"
!define MODEL "FlatFitFab.Model"
!define FLATFAB "FlatFitFab.FlatFab"

Name "FlatFitFab"
OutFile "${OUTPUT}"
InstallDir "" ; .onInit: it depends on who installs
BrandingText "FlatFitFab ${VERSION}"
VIProductVersion "${VERSION}.0"
VIAddVersionKey ProductName "FlatFitFab"
VIAddVersionKey ProductVersion "${VERSION}"
VIAddVersionKey FileVersion "${VERSION}"
VIAddVersionKey FileDescription "Installs FlatFitFab"
VIAddVersionKey LegalCopyright "GNU General Public License, version 3 or later"

!define MUI_ICON "${ICON}"
!define MUI_UNICON "${ICON}"
!define MUI_FINISHPAGE_RUN "$INSTDIR\flatfitfab.exe"
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!insertmacro MUI_PAGE_FINISH
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES

; The languages of the program; Windows's own is taken, the first where it is none of these.
!macro Language name open model flatfab
    !insertmacro MUI_LANGUAGE "${name}"
    LangString OPEN ${LANG_${name}} "${open}"
    LangString MODEL_NAME ${LANG_${name}} "${model}"
    LangString FLATFAB_NAME ${LANG_${name}} "${flatfab}"
!macroend
!insertmacro Language English "FlatFitFab is open. Close it first." "FlatFitFab model" "FlatFab model"
!insertmacro Language German "FlatFitFab ist geöffnet. Schließe es erst." "FlatFitFab-Modell" "FlatFab-Modell"
!insertmacro Language Spanish "FlatFitFab está abierto. Ciérralo primero." "Modelo de FlatFitFab" "Modelo de FlatFab"
!insertmacro Language French "FlatFitFab est ouvert. Fermez-le d’abord." "Modèle FlatFitFab" "Modèle FlatFab"
!insertmacro Language Italian "FlatFitFab è aperto. Chiudilo prima." "Modello di FlatFitFab" "Modello di FlatFab"
!insertmacro Language Japanese "FlatFitFab が開いています。先に閉じてください。" "FlatFitFab モデル" "FlatFab モデル"
!insertmacro Language Dutch "FlatFitFab is geopend. Sluit het eerst." "FlatFitFab-model" "FlatFab-model"
!insertmacro Language Polish "FlatFitFab jest otwarty. Najpierw go zamknij." "Model FlatFitFab" "Model FlatFab"
!insertmacro Language PortugueseBR "O FlatFitFab está aberto. Feche-o primeiro." "Modelo do FlatFitFab" "Modelo do FlatFab"
!insertmacro Language SimpChinese "FlatFitFab 正在运行。请先将其关闭。" "FlatFitFab 模型" "FlatFab 模型"

; Whoever starts either program without the rights that it needs gets nothing half done.
!macro ForEverybody
    SetShellVarContext all
    UserInfo::GetAccountType
    Pop $0
    ${If} $0 != "Admin"
        MessageBox MB_OK|MB_ICONSTOP "Installing for all users takes an administrator." /SD IDOK
        SetErrorLevel 2
        Quit
    ${EndIf}
!macroend

; Windows writes into no program that runs.
!macro WaitUntilClosed
    ${Do}
        ClearErrors
        ${IfNot} ${FileExists} "$INSTDIR\flatfitfab.exe"
            ${ExitDo}
        ${EndIf}
        FileOpen $0 "$INSTDIR\flatfitfab.exe" a
        ${IfNot} ${Errors}
            FileClose $0
            ${ExitDo}
        ${EndIf}
        MessageBox MB_RETRYCANCEL|MB_ICONEXCLAMATION "$(OPEN)" /SD IDCANCEL IDRETRY +3
            SetErrorLevel 3
            Quit
    ${Loop}
!macroend

!macro TellWindows
    ; The kinds of files have changed (SHCNE_ASSOCCHANGED).
    System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, p 0, p 0)'
!macroend

Function .onInit
    SetRegView 64
    SetShellVarContext current
    StrCpy $1 "$LOCALAPPDATA\Programs\FlatFitFab"
    ${GetParameters} $0
    ClearErrors
    ${GetOptions} $0 "/AllUsers" $0
    ${IfNot} ${Errors}
        !insertmacro ForEverybody
        StrCpy $1 "$PROGRAMFILES64\FlatFitFab"
    ${EndIf}
    ${If} $INSTDIR == "" ; no /D: where it was before, or the usual place
        ReadRegStr $INSTDIR SHCTX "${OF_PROGRAM}" InstallLocation
    ${EndIf}
    ${If} $INSTDIR == ""
        StrCpy $INSTDIR $1
    ${EndIf}
FunctionEnd

Section
    !insertmacro WaitUntilClosed
    ; What an older version had, and this has not, goes with it.
    ReadRegStr $0 SHCTX "${OF_PROGRAM}" InstallLocation
    ${If} ${FileExists} "$0\uninstall.exe"
        ExecWait '"$0\uninstall.exe" /S _?=$0'
        Delete "$0\uninstall.exe"
        RMDir "$0"
    ${EndIf}

    !insertmacro InstallFiles
    SetOutPath "$INSTDIR" ; where the shortcut starts it
    WriteUninstaller "$INSTDIR\uninstall.exe"
    CreateShortcut "$SMPROGRAMS\FlatFitFab.lnk" "$INSTDIR\flatfitfab.exe"

    WriteRegStr SHCTX "${OF_PROGRAM}" DisplayName "FlatFitFab"
    WriteRegStr SHCTX "${OF_PROGRAM}" DisplayVersion "${VERSION}"
    WriteRegStr SHCTX "${OF_PROGRAM}" DisplayIcon "$INSTDIR\flatfitfab.exe"
    WriteRegStr SHCTX "${OF_PROGRAM}" Publisher "The makers of FlatFitFab"
    WriteRegStr SHCTX "${OF_PROGRAM}" InstallLocation "$INSTDIR"
    WriteRegStr SHCTX "${OF_PROGRAM}" UninstallString '"$INSTDIR\uninstall.exe"'
    WriteRegStr SHCTX "${OF_PROGRAM}" QuietUninstallString '"$INSTDIR\uninstall.exe" /S'
    WriteRegDWORD SHCTX "${OF_PROGRAM}" EstimatedSize ${SIZE}
    WriteRegDWORD SHCTX "${OF_PROGRAM}" NoModify 1
    WriteRegDWORD SHCTX "${OF_PROGRAM}" NoRepair 1

    ; .fff is ours; a .txt seldom is: there we are one of those that can open it.
    WriteRegStr SHCTX "${CLASSES}\${MODEL}" "" "$(MODEL_NAME)"
    WriteRegStr SHCTX "${CLASSES}\${MODEL}\DefaultIcon" "" "$INSTDIR\flatfitfab.exe,0"
    WriteRegStr SHCTX "${CLASSES}\${MODEL}\shell\open\command" "" '"$INSTDIR\flatfitfab.exe" "%1"'
    WriteRegStr SHCTX "${CLASSES}\.fff" "" "${MODEL}"
    WriteRegStr SHCTX "${CLASSES}\.fff" "Content Type" "application/x-flatfitfab"
    WriteRegStr SHCTX "${CLASSES}\.fff\OpenWithProgids" "${MODEL}" ""
    WriteRegStr SHCTX "${CLASSES}\${FLATFAB}" "" "$(FLATFAB_NAME)"
    WriteRegStr SHCTX "${CLASSES}\${FLATFAB}\shell\open\command" "" '"$INSTDIR\flatfitfab.exe" "%1"'
    WriteRegStr SHCTX "${CLASSES}\.txt\OpenWithProgids" "${FLATFAB}" ""
    !insertmacro TellWindows
SectionEnd

Function un.onInit
    SetRegView 64
    SetShellVarContext current
    ReadRegStr $0 HKLM "${OF_PROGRAM}" InstallLocation
    ${If} $0 == $INSTDIR
        UserInfo::GetAccountType
        Pop $0
        ${If} $0 != "Admin"
        ${AndIfNot} ${Silent}
            ExecShell runas "$INSTDIR\uninstall.exe" ; Windows asks for an administrator
            Quit
        ${EndIf}
        !insertmacro ForEverybody
    ${EndIf}
FunctionEnd

Section Uninstall
    !insertmacro WaitUntilClosed
    ; File by file: what somebody else put there, such as defaults.ini, stays, and so does its folder.
    !insertmacro RemoveFiles
    Delete "$INSTDIR\uninstall.exe"
    SetOutPath "$TEMP" ; no folder can be removed that a program is in
    RMDir "$INSTDIR"
    Delete "$SMPROGRAMS\FlatFitFab.lnk"

    DeleteRegKey SHCTX "${OF_PROGRAM}"
    DeleteRegKey SHCTX "${CLASSES}\${MODEL}"
    DeleteRegKey SHCTX "${CLASSES}\${FLATFAB}"
    ReadRegStr $0 SHCTX "${CLASSES}\.fff" ""
    ${If} $0 == "${MODEL}"
        DeleteRegValue SHCTX "${CLASSES}\.fff" ""
        DeleteRegValue SHCTX "${CLASSES}\.fff" "Content Type"
    ${EndIf}
    DeleteRegValue SHCTX "${CLASSES}\.fff\OpenWithProgids" "${MODEL}"
    DeleteRegValue SHCTX "${CLASSES}\.txt\OpenWithProgids" "${FLATFAB}"
    ; Where nobody else has said anything of them.
    DeleteRegKey /ifnosubkeys /ifnovalues SHCTX "${CLASSES}\.fff\OpenWithProgids"
    DeleteRegKey /ifnosubkeys /ifnovalues SHCTX "${CLASSES}\.fff"
    DeleteRegKey /ifnosubkeys /ifnovalues SHCTX "${CLASSES}\.txt\OpenWithProgids"
    DeleteRegKey /ifnosubkeys /ifnovalues SHCTX "${CLASSES}\.txt"
    !insertmacro TellWindows
SectionEnd
