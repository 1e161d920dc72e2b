@echo off
rem check.bat EXERCISE FILE - check a solution, for example: check.bat 03_2 my.frag
rem You may drop a file on check.bat; it then asks for the exercise. Like make check, it compares pictures and nine rays
rem of the file with those of the solution. Exit status: 0 right, 1 wrong, 2 if nothing could be compared.
setlocal
set "exercise=%~1"
set "given=%~2"
set "file=%~f2"
set "dropped="
if not "%~2"=="" goto asked
set "dropped=yes"
if "%~1"=="" goto usage
if exist "%~f1" goto one
set "dropped="
goto usage
:one
set "given=%~1"
set "file=%~f1"
set /p "exercise=Which exercise? For example 03_2: "
:asked
pushd "%~dp0"
if not exist "exercises\%exercise%.txt" goto unknown
if not exist "%file%" goto missing
set "folder=%TEMP%\ray-marching-check"
if not exist "%folder%" mkdir "%folder%"
set "program="
set "rayed="
set "shares="
set "status=0"
for /f "usebackq tokens=1-4 delims=|" %%a in ("exercises\%exercise%.txt") do call :line "%%a" "%%b" "%%c" "%%d"
if not %status%==0 goto end
judge.exe right %shares% >"%folder%\said.txt"
for /f "usebackq delims=" %%w in ("%folder%\said.txt") do echo "%given%": right: %%w
goto end

rem A line of the exercise. The first line has what all pictures have in common; each other line describes one picture.
:line
if not %status%==0 goto :eof
if defined program goto picture
set "program=%~1.exe"
set "solution=chapters\solutions\%~2.frag"
set "places=%~3"
set "probes=%~4"
goto :eof
:picture
set "options=%~2"
set "shown=%~3"
rem Pictures left over from an earlier comparison must not be mistaken for new ones if a program fails.
del /q "%folder%\*.png" 2>nul
"%program%" %~1 --shader "%solution%" --output "%folder%\solution.png"
if errorlevel 1 goto broken
"%program%" %~1 --shader "%file%" --output "%folder%\yours.png"
if errorlevel 1 goto fails
judge.exe picture "%shown%" "%folder%\solution.png" "%folder%\yours.png" "%folder%\difference.png" >"%folder%\said.txt"
if errorlevel 2 goto broken
if errorlevel 1 goto differs
for /f "usebackq skip=1 delims=" %%w in ("%folder%\said.txt") do set "shares=%shares% %%w"
if defined rayed goto :eof
set "rayed=yes"
"%program%" %options% --shader "%solution%" %probes% >"%folder%\solution.txt" 2>nul
"%program%" %options% --shader "%file%" %probes% >"%folder%\yours.txt" 2>nul
judge.exe rays "%shown%" "%places%" "%folder%\solution.txt" "%folder%\yours.txt" >"%folder%\said.txt"
if not errorlevel 1 goto :eof
set "status=1"
for /f "usebackq delims=" %%w in ("%folder%\said.txt") do echo "%given%": wrong: %%w
goto :eof
:differs
set "status=1"
set "place="
for /f "usebackq delims=" %%w in ("%folder%\said.txt") do if not defined place set "place=%%w"
for /f "usebackq skip=2 delims=" %%w in ("%folder%\said.txt") do echo "%given%": wrong: %%w
echo   see difference.png, yours.png and solution.png in %folder%
echo   look at yours: .\%program% --shader "%file%" %shown%
call :ray "your pixel %place% from the lower left" "%file%"
call :ray "the solution's" "%solution%"
goto :eof
:ray
"%program%" %options% --shader "%~2" --probe=%place% >"%folder%\ray.txt" 2>nul
judge.exe ray "%folder%\ray.txt" >"%folder%\said.txt"
for /f "usebackq delims=" %%w in ("%folder%\said.txt") do echo   %~1: %%w
goto :eof
:fails
set "status=1"
echo "%given%": wrong: does not run: see the lines above
goto :eof
:broken
set "status=2"
echo "%given%": cannot be compared: see the lines above
goto :eof

:unknown
echo %exercise%: there is no such exercise: give a chapter and a number, such as 03_2
popd
goto usage
:missing
echo "%given%": there is no such file
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
