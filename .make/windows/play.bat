@echo off
rem play.bat [FILE.frag] - open your own shader in a window, reloaded on every save. You may drop a file on play.bat.
rem Without a file: chapters\play.frag, which is created and opened in Notepad.
setlocal
set "file=%~f1"
pushd "%~dp0"
if not "%~1"=="" goto open
set "file=chapters\play.frag"
if exist "%file%" goto edit
copy "chapters\first_steps\play.frag" "%file%" >nul
if errorlevel 1 goto failed
:edit
start "" notepad "%file%"
:open
01_normal_colouring.exe --shader "%file%"
if errorlevel 1 goto failed
popd
exit /b 0
:failed
popd
pause
exit /b 1
