# Without arguments lsysc says what it is for; that is no success.
lsysc
echo "status $?"
