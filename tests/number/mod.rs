mod lane;
