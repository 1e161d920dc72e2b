@echo off
rem check.bat EXERCISE FILE - is a solution right? For example: check.bat 03_2 my.frag
rem A file may be dropped on it; then it asks for the exercise. The pictures of the file are compared with those of
rem the solution. Exit status: 0 where they are the same, 1 where they are not, 2 where nothing could be compared.
setlocal
set "exercise=%~1"
set "file=%~f2"
set "dropped="
if not "%~2"=="" goto asked
set "dropped=yes"
if "%~1"=="" goto usage
set "file=%~f1"
if not exist "%file%" goto usage
set /p "exercise=Which exercise? For example 03_2: "
:asked
pushd "%~dp0"
if not exist "exercises\%exercise%.txt" goto unknown
if not exist "%file%" goto missing
set "folder=%TEMP%\ray-marching-check"
if not exist "%folder%" mkdir "%folder%"
set "program="
set "number=0"
set "status=0"
for /f "usebackq delims=" %%l in ("exercises\%exercise%.txt") do call :line %%l
if %status%==0 echo %file%: right: as the solution in all %number% pictures
goto end

:line
if not %status%==0 goto :eof
if defined program goto picture
set "program=%1.exe"
set "solution=chapters\solutions\%2.frag"
goto :eof
:picture
set /a number=number+1 >nul
"%program%" %* --shader "%solution%" --output "%folder%\solution.png"
if errorlevel 1 goto broken
"%program%" %* --shader "%file%" --output "%folder%\yours.png"
if errorlevel 1 goto broken
compare.exe --words "%folder%\solution.png" "%folder%\yours.png" "%folder%\difference.png" >"%folder%\words.txt"
if not errorlevel 1 goto :eof
set "status=1"
echo %file%: wrong with %*:
type "%folder%\words.txt"
echo Look at yours.png, solution.png and difference.png in %folder%
goto :eof
:broken
echo %file%: cannot be compared with %*: see the lines above
set "status=2"
goto :eof

:unknown
echo %exercise%: there is no such exercise: give a chapter and a number, as 03_2
popd
goto usage
:missing
echo %file%: there is no such file
set "status=2"
goto end
:usage
echo check.bat EXERCISE FILE, for example: check.bat 03_2 my.frag
if defined dropped pause
exit /b 2
:end
popd
if defined dropped pause
exit /b %status%
