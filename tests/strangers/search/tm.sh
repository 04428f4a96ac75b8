# helper: tmux session
tmux -L search kill-server 2>/dev/null; tmux -L search new-session -d -x 80 -y 24 -s t "env HOME=/tmp/search-home LANG=de_DE.UTF-8 PS1='$ ' PATH=$PATH bash --norc"
