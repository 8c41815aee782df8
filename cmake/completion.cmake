# Puts the commands' option lines, file OPTIONS, into the template FROM; writes TO.
file(READ ${OPTIONS} OPTIONS)
string(STRIP "${OPTIONS}" OPTIONS)
configure_file(${FROM} ${TO} @ONLY)
